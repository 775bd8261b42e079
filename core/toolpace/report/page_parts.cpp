#include "toolpace/report/page_parts.h"

namespace toolpace::page {
namespace {

constexpr const char* kStyle = R"(
:root{--ground:#f5f6f8;--surface:#fff;--line:#d7dbe0;--text:#1b1f24;--second:#5b6470;--accent:#0b6bcb;--error:#c62828;--good:#2e7d32}
@media(prefers-color-scheme:dark){:root{--ground:#14171b;--surface:#1c2026;--line:#2e343c;--text:#e6e9ed;--second:#98a2ae;--accent:#4da3ff;--error:#ff6b6b;--good:#6bcb77}}
body{background:var(--ground);color:var(--text);font:14px/1.5 system-ui,"WenQuanYi Micro Hei",sans-serif;max-width:1040px;margin:24px auto;padding:0 16px}
h1{font-size:22px}h2{font-size:16px;margin-top:28px}
table{border-collapse:collapse;background:var(--surface);width:100%}td,th{border-bottom:1px solid var(--line);padding:4px 8px;text-align:right;font-variant-numeric:tabular-nums}
td:first-child,th:first-child{text-align:left}th{color:var(--second);font-weight:normal}
svg{background:var(--surface);border:1px solid var(--line);width:100%;margin-bottom:8px}svg text{fill:var(--second);font-size:12px}
svg .y{text-anchor:end}svg .x{text-anchor:middle}svg .title{fill:var(--text)}.grid{stroke:var(--line)}.zero{stroke:var(--second)}
.curve{fill:var(--accent);stroke:var(--accent);stroke-width:1.2;stroke-linejoin:round}.contour path{fill:none;stroke-width:1.4;stroke-linecap:round}.contour{background:#fff}
.bar{display:inline-block;height:10px;background:var(--accent)}.broken{color:var(--error);font-weight:bold}.good{color:var(--good);font-weight:bold}
.legend{color:var(--second)}.legend i{display:inline-block;width:28px;height:10px}
h2{break-after:avoid}svg,tr,.legend{break-inside:avoid}
@media print{:root{--ground:#fff;--surface:#fff;--line:#d7dbe0;--text:#000;--second:#444;--accent:#0b6bcb;--error:#c62828;--good:#2e7d32}body{max-width:none;margin:0;font-size:11px;print-color-adjust:exact;-webkit-print-color-adjust:exact}}
)";

std::string file_name(const std::string& program) { return program.substr(program.find_last_of('/') + 1); }

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string whole(const std::string& program_name, const std::string& body) {
  const std::string title = escaped(file_name(program_name));
  return "<!DOCTYPE html>\n<html lang='en'>\n<head>\n<meta charset='utf-8'>\n<title>" + title + "</title>\n<style>" +
         kStyle + "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n" + body + "</body>\n</html>\n";
}

}  // namespace toolpace::page
