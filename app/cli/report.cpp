#include "report.h"

#include <cstdio>

#include "console.h"
#include "interrupt.h"
#include "toolpace/base/error_text.h"

namespace toolpace::cli {

void tell(const std::string& text) {
  if (Console* other = console()) return other->tell(text);
  if (is_interrupted() && std::ferror(stderr) != 0) return;  // it waited for a reader, and is not to wait again
  std::fputs(text.c_str(), stderr);
}

ExitCode exit_code(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage: return kBadUsage;
    case ErrorKind::input:
    case ErrorKind::infeasible: return kBadInput;
    case ErrorKind::io: return kFileTrouble;
    case ErrorKind::cancelled: return kInterrupted;
  }
  return kBadInput;
}

ExitCode report(const Error& error) {
  tell(error_text(error));
  return exit_code(error.kind);
}

void report(const Diagnostic& diagnostic) { tell(diagnostic_text(diagnostic)); }

void report(const Diagnostics& diagnostics) {
  for (const auto& d : diagnostics) report(d);
}

Json to_json(const Failure& failure) {
  const Error& e = failure.error;
  Json error = {{"code", e.code}, {"message", e.message}, {"remedy", e.remedy}};
  error["file"] = nullptr;
  if (!e.where.file.empty()) error["file"] = e.where.file;
  error["line"] = e.where.line;
  error["column"] = e.where.column;
  error["attainable"] = nullptr;
  if (e.attainable) error["attainable"] = *e.attainable;
  return {{"error", std::move(error)},
          {"exit_code", static_cast<int>(exit_code(e.kind))},
          {"diagnostics", to_json(failure.diagnostics)}};
}

Json to_json(const Diagnostics& diagnostics) {
  auto list = Json::array();
  for (const Diagnostic& d : diagnostics) {
    list.push_back({{"severity", severity_word(d.severity)},
                    {"code", d.code},
                    {"file", d.where.file},
                    {"line", d.where.line},
                    {"column", d.where.column},
                    {"message", d.message},
                    {"excerpt", d.excerpt},
                    {"remedy", d.remedy}});
  }
  return list;
}

void print_json(const Json& json) {
  if (Console* other = console()) return other->answer(json);
  // Not by fmt::print, which throws: main tells what goes wrong with standard output.
  const std::string text = json.text() + '\n';
  std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace toolpace::cli
