#include "toolpace/io/zip_archive.h"

#include <zlib.h>

#include <utility>

namespace toolpace {
namespace {

constexpr std::uint16_t kVersionZip64 = 45;
constexpr std::uint16_t kFirstDosDate = (1U << 5U) | 1U;  // 1 January 1980: no clock here, so same input, same bytes
constexpr std::uint32_t kSeeZip64 = 0xFFFFFFFFU;

template <class Integer>
void put(std::string& out, Integer value) {
  for (std::size_t i = 0; i < sizeof(Integer); ++i)
    out.push_back(static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i)));
}

std::uint32_t checksum(std::uint32_t before, std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// Fields that the local header and the directory share: version … name length.
void put_common(std::string& out, std::uint32_t crc, std::size_t name_bytes) {
  put<std::uint16_t>(out, kVersionZip64);
  put<std::uint16_t>(out, 0);  // flags
  put<std::uint16_t>(out, 0);  // stored
  put<std::uint16_t>(out, 0);  // time
  put<std::uint16_t>(out, kFirstDosDate);
  put<std::uint32_t>(out, crc);
  put<std::uint32_t>(out, kSeeZip64);
  put<std::uint32_t>(out, kSeeZip64);
  put<std::uint16_t>(out, static_cast<std::uint16_t>(name_bytes));
}

}  // namespace

Result<void> ZipArchive::begin_entry(std::string_view name, std::size_t head_bytes) {
  Entry entry;
  entry.name = name;
  entry.offset = file_.size();
  entry.head_bytes = head_bytes;
  entries_.push_back(std::move(entry));
  return file_.write(local_header(entries_.back()));
}

Result<void> ZipArchive::write(std::string_view bytes) {
  Entry& entry = entries_.back();
  std::string_view body = bytes;
  if (entry.size < entry.head_bytes) {
    entry.head_crc = checksum(0, bytes.substr(0, entry.head_bytes));
    body.remove_prefix(entry.head_bytes);
  }
  entry.body_crc = checksum(entry.body_crc, body);
  entry.size += bytes.size();
  return file_.write(bytes);
}

Result<void> ZipArchive::replace_head(std::string_view head) {
  Entry& entry = entries_.back();
  entry.head_crc = checksum(0, head);
  return file_.overwrite(entry.offset + local_header(entry).size(), head);
}

Result<void> ZipArchive::end_entry() { return file_.overwrite(entries_.back().offset, local_header(entries_.back())); }

std::uint32_t ZipArchive::crc(const Entry& entry) const {
  const auto body = static_cast<z_off64_t>(entry.size - std::min(entry.size, entry.head_bytes));
  return static_cast<std::uint32_t>(crc32_combine64(entry.head_crc, entry.body_crc, body));
}

std::string ZipArchive::local_header(const Entry& entry) const {
  std::string out = "PK\x03\x04";
  put_common(out, crc(entry), entry.name.size());
  put<std::uint16_t>(out, 20);  // bytes of the extra field
  out += entry.name;
  put<std::uint16_t>(out, 1);  // zip64
  put<std::uint16_t>(out, 16);
  put<std::uint64_t>(out, entry.size);
  put<std::uint64_t>(out, entry.size);
  return out;
}

std::string ZipArchive::directory_header(const Entry& entry) const {
  std::string out = "PK\x01\x02";
  put<std::uint16_t>(out, kVersionZip64);  // made by
  put_common(out, crc(entry), entry.name.size());
  put<std::uint16_t>(out, 28);  // bytes of the extra field
  put<std::uint16_t>(out, 0);   // comment
  put<std::uint16_t>(out, 0);   // disk
  put<std::uint16_t>(out, 0);   // internal attributes
  put<std::uint32_t>(out, 0);   // external attributes
  put<std::uint32_t>(out, kSeeZip64);
  out += entry.name;
  put<std::uint16_t>(out, 1);
  put<std::uint16_t>(out, 24);
  put<std::uint64_t>(out, entry.size);
  put<std::uint64_t>(out, entry.size);
  put<std::uint64_t>(out, entry.offset);
  return out;
}

Result<void> ZipArchive::finish() {
  const std::uint64_t start = file_.size();
  std::string out;
  for (const Entry& entry : entries_) out += directory_header(entry);
  const std::uint64_t bytes = out.size();
  out += "PK\x06\x06";
  put<std::uint64_t>(out, 44);  // bytes of this record that follow
  put<std::uint16_t>(out, kVersionZip64);
  put<std::uint16_t>(out, kVersionZip64);
  put<std::uint32_t>(out, 0);
  put<std::uint32_t>(out, 0);
  put<std::uint64_t>(out, entries_.size());
  put<std::uint64_t>(out, entries_.size());
  put<std::uint64_t>(out, bytes);
  put<std::uint64_t>(out, start);
  out += "PK\x06\x07";
  put<std::uint32_t>(out, 0);
  put<std::uint64_t>(out, start + bytes);
  put<std::uint32_t>(out, 1);
  out += "PK\x05\x06";
  put<std::uint32_t>(out, 0);
  put<std::uint16_t>(out, static_cast<std::uint16_t>(entries_.size()));
  put<std::uint16_t>(out, static_cast<std::uint16_t>(entries_.size()));
  put<std::uint32_t>(out, kSeeZip64);
  put<std::uint32_t>(out, kSeeZip64);
  put<std::uint16_t>(out, 0);
  if (auto done = file_.write(out); !done) return done;
  return file_.commit();
}

}  // namespace toolpace
