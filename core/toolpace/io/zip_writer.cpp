#include "toolpace/io/zip_writer.h"

#include <zip.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

namespace toolpace::detail {
namespace {

constexpr zip_uint16_t kNoTime = 0;
constexpr zip_uint16_t kFirstDate = (1U << 5U) | 1U;  // 1 January 1980, where the calendar of archives begins

/// What libzip asks for, answered by one of ours. The first error is kept: libzip would tell but its number.
class Source {
 public:
  explicit Source(std::optional<Error>& failure) : failure_(failure) { zip_error_init(&error_); }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() { zip_error_fini(&error_); }

  static zip_int64_t answer(void* self, void* data, zip_uint64_t length, zip_source_cmd_t command) {
    auto& source = *static_cast<Source*>(self);
    if (command == ZIP_SOURCE_ERROR) return zip_error_to_data(&source.error_, data, length);
    if (command == ZIP_SOURCE_FREE) return 0;
    return source.run(data, length, command);
  }

 protected:
  virtual zip_int64_t run(void* data, zip_uint64_t length, zip_source_cmd_t command) = 0;

  zip_int64_t fail(int code, int number = 0) {
    zip_error_set(&error_, code, number);
    return -1;
  }
  zip_int64_t fail(Error why, int code) {
    if (!failure_) failure_ = std::move(why);
    return fail(code);
  }
  zip_error_t& error() { return error_; }

 private:
  std::optional<Error>& failure_;
  zip_error_t error_ = {};
};

/// The content of an entry, read from its beginning to its end.
class EntrySource final : public Source {
 public:
  EntrySource(const ZipEntry& entry, std::optional<Error>& failure) : Source(failure), entry_(entry) {}

 private:
  zip_int64_t run(void* data, zip_uint64_t length, zip_source_cmd_t command) override {
    switch (command) {
      case ZIP_SOURCE_SUPPORTS: return ZIP_SOURCE_SUPPORTS_READABLE;
      case ZIP_SOURCE_OPEN: at_ = 0; return 0;
      case ZIP_SOURCE_READ: return read(static_cast<char*>(data), length);
      case ZIP_SOURCE_CLOSE: return 0;
      case ZIP_SOURCE_STAT: return tell_size(data, length);
      default: return fail(ZIP_ER_OPNOTSUPP);
    }
  }

  zip_int64_t read(char* out, zip_uint64_t length) {
    const std::size_t head = entry_.head.size();
    if (at_ < head) {
      const std::size_t n = std::min<std::size_t>(length, head - at_);
      std::memcpy(out, entry_.head.data() + at_, n);
      at_ += n;
      return static_cast<zip_int64_t>(n);
    }
    if (entry_.body == nullptr) return 0;
    auto n = entry_.body->read(at_ - head, out, length);
    if (!n) return fail(std::move(n.error()), ZIP_ER_READ);
    at_ += *n;
    return static_cast<zip_int64_t>(*n);
  }

  zip_int64_t tell_size(void* data, zip_uint64_t length) {
    if (length < sizeof(zip_stat_t)) return fail(ZIP_ER_INVAL);
    auto* const stat = static_cast<zip_stat_t*>(data);
    zip_stat_init(stat);
    stat->size = entry_.head.size() + (entry_.body == nullptr ? 0 : entry_.body->size());
    stat->valid = ZIP_STAT_SIZE;
    return sizeof(zip_stat_t);
  }

  const ZipEntry& entry_;
  std::uint64_t at_ = 0;
};

/// The archive that comes to be.
class ArchiveSource final : public Source {
 public:
  ArchiveSource(OutputFile& file, std::optional<Error>& failure) : Source(failure), file_(file) {}

 private:
  zip_int64_t run(void* data, zip_uint64_t length, zip_source_cmd_t command) override {
    switch (command) {
      case ZIP_SOURCE_SUPPORTS: return ZIP_SOURCE_SUPPORTS_WRITABLE;
      case ZIP_SOURCE_STAT: return fail(ZIP_ER_READ, ENOENT);  // there is none yet
      case ZIP_SOURCE_BEGIN_WRITE:
      case ZIP_SOURCE_COMMIT_WRITE:
      case ZIP_SOURCE_ROLLBACK_WRITE:
      case ZIP_SOURCE_REMOVE: return 0;
      case ZIP_SOURCE_WRITE: return write({static_cast<const char*>(data), length});
      case ZIP_SOURCE_SEEK_WRITE: return seek(data, length);
      case ZIP_SOURCE_TELL_WRITE: return static_cast<zip_int64_t>(at_);
      default: return fail(ZIP_ER_OPNOTSUPP);
    }
  }

  zip_int64_t write(std::string_view bytes) {
    const std::string_view old = bytes.substr(0, std::min<std::uint64_t>(bytes.size(), file_.size() - at_));
    const std::string_view more = bytes.substr(old.size());
    if (!old.empty()) {
      if (auto done = file_.overwrite(at_, old); !done) return fail(std::move(done.error()), ZIP_ER_WRITE);
    }
    if (!more.empty()) {
      if (auto done = file_.write(more); !done) return fail(std::move(done.error()), ZIP_ER_WRITE);
    }
    at_ += bytes.size();
    return static_cast<zip_int64_t>(bytes.size());
  }

  zip_int64_t seek(void* arguments, zip_uint64_t length) {
    const zip_int64_t place = zip_source_seek_compute_offset(at_, file_.size(), arguments, length, &error());
    if (place < 0) return -1;
    at_ = static_cast<std::uint64_t>(place);
    return 0;
  }

  OutputFile& file_;
  std::uint64_t at_ = 0;
};

/// Adds an entry that is stored as it is, without a time. @return false = libzip says why
bool add(zip_t* archive, const ZipEntry& entry, EntrySource& content) {
  zip_source_t* const source = zip_source_function(archive, &Source::answer, static_cast<Source*>(&content));
  if (source == nullptr) return false;
  const zip_int64_t index = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const auto at = static_cast<zip_uint64_t>(index);
  return zip_set_file_compression(archive, at, ZIP_CM_STORE, 0) == 0 &&
         zip_file_set_dostime(archive, at, kNoTime, kFirstDate, 0) == 0;
}

}  // namespace

Result<void> write_zip(OutputFile& file, const std::vector<ZipEntry>& entries) {
  std::optional<Error> failure;
  ArchiveSource target(file, failure);
  std::vector<std::unique_ptr<EntrySource>> contents;
  zip_error_t trouble;
  zip_error_init(&trouble);
  zip_source_t* const source = zip_source_function_create(&Source::answer, static_cast<Source*>(&target), &trouble);
  zip_t* const archive =
      source == nullptr ? nullptr : zip_open_from_source(source, ZIP_CREATE | ZIP_TRUNCATE, &trouble);
  std::string why = zip_error_strerror(&trouble);
  zip_error_fini(&trouble);
  const auto give_up = [&]() -> Result<void> {
    if (failure) return tl::unexpected(std::move(*failure));
    return tl::unexpected(Error{
        ErrorKind::io, "cannot-write", "cannot write this archive: " + why, "", {file.target().string(), 0, 0}, {}});
  };
  if (archive == nullptr) {
    if (source != nullptr) zip_source_free(source);
    return give_up();
  }
  bool fine = true;
  for (const ZipEntry& entry : entries) {
    contents.push_back(std::make_unique<EntrySource>(entry, failure));
    fine = fine && add(archive, entry, *contents.back());
  }
  if (!fine || zip_close(archive) != 0) {
    why = zip_strerror(archive);
    zip_discard(archive);
    return give_up();
  }
  return file.commit();
}

}  // namespace toolpace::detail
