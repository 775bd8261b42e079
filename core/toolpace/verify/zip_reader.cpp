#include "toolpace/verify/zip_reader.h"

#include <zip.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "toolpace/verify/setpoint_readers.h"

namespace toolpace::detail {

/// The file as libzip reads it. What goes wrong with the file itself is kept: libzip would tell but its number.
struct ZipReader::Source {
  InputFile file;
  std::uint64_t at = 0;
  std::optional<Error> failure = {};
  zip_error_t error = {};

  explicit Source(InputFile f) : file(std::move(f)) { zip_error_init(&error); }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  ~Source() { zip_error_fini(&error); }

  zip_int64_t read(void* out, zip_uint64_t count) {
    const std::uint64_t n = std::min<std::uint64_t>(count, file.size() - std::min(at, file.size()));
    if (auto done = file.read(at, static_cast<char*>(out), static_cast<std::size_t>(n)); !done) {
      failure = std::move(done.error());
      zip_error_set(&error, ZIP_ER_READ, 0);
      return -1;
    }
    at += n;
    return static_cast<zip_int64_t>(n);
  }

  zip_int64_t seek(void* arguments, zip_uint64_t length) {
    const zip_int64_t place = zip_source_seek_compute_offset(at, file.size(), arguments, length, &error);
    if (place < 0) return -1;
    at = static_cast<std::uint64_t>(place);
    return 0;
  }

  zip_int64_t tell_size(void* out, zip_uint64_t length) {
    if (length < sizeof(zip_stat_t)) return -1;
    auto* const stat = static_cast<zip_stat_t*>(out);
    zip_stat_init(stat);
    stat->size = file.size();
    stat->valid = ZIP_STAT_SIZE;
    return sizeof(zip_stat_t);
  }

  static zip_int64_t answer(void* self, void* data, zip_uint64_t length, zip_source_cmd_t command) {
    auto& source = *static_cast<Source*>(self);
    switch (command) {
      case ZIP_SOURCE_SUPPORTS: return ZIP_SOURCE_SUPPORTS_SEEKABLE;
      case ZIP_SOURCE_OPEN: source.at = 0; return 0;
      case ZIP_SOURCE_READ: return source.read(data, length);
      case ZIP_SOURCE_SEEK: return source.seek(data, length);
      case ZIP_SOURCE_TELL: return static_cast<zip_int64_t>(source.at);
      case ZIP_SOURCE_STAT: return source.tell_size(data, length);
      case ZIP_SOURCE_ERROR: return zip_error_to_data(&source.error, data, length);
      case ZIP_SOURCE_CLOSE:
      case ZIP_SOURCE_FREE: return 0;
      default: zip_error_set(&source.error, ZIP_ER_OPNOTSUPP, 0); return -1;
    }
  }
};

/// One entry, opened anew for each pass over it: compressed ones know no way back.
class ZipReader::Entry final : public ByteStream {
 public:
  Entry(std::shared_ptr<ZipReader> reader, zip_uint64_t index, std::string name, std::uint64_t size)
      : reader_(std::move(reader)), index_(index), name_(std::move(name)), size_(size) {}
  ~Entry() override { rewind(); }

  std::uint64_t size() const override { return size_; }

  Result<void> read(char* out, std::size_t count) override {
    if (auto opened = open(); !opened) return opened;
    while (count > 0) {
      const zip_int64_t n = zip_fread(file_, out, count);
      if (n < 0) return tl::unexpected(trouble());
      if (n == 0) return tl::unexpected(reader_->error(name_, "it is shorter than the archive says"));
      out += n;
      count -= static_cast<std::size_t>(n);
    }
    return {};
  }

  /// The checksum is judged where the end of the entry is read.
  Result<void> finish() override {
    if (auto opened = open(); !opened) return opened;
    char more = 0;
    const zip_int64_t n = zip_fread(file_, &more, 1);
    if (n < 0) return tl::unexpected(trouble());
    if (n > 0) return tl::unexpected(reader_->error(name_, "it is longer than the archive says"));
    return reader_->source_->file.check_unchanged();
  }

  void rewind() override {
    if (file_ != nullptr) zip_fclose(std::exchange(file_, nullptr));
  }

 private:
  Result<void> open() {
    if (file_ != nullptr) return {};
    file_ = zip_fopen_index(reader_->archive_, index_, 0);
    if (file_ != nullptr) return {};
    return tl::unexpected(reader_->error(name_, zip_strerror(reader_->archive_)));
  }

  Error trouble() const { return reader_->error(name_, zip_file_strerror(file_)); }

  std::shared_ptr<ZipReader> reader_;
  zip_uint64_t index_;
  std::string name_;
  std::uint64_t size_;
  zip_file_t* file_ = nullptr;
};

/// @param what  the entry, or nothing for the archive as a whole
Error ZipReader::error(const std::string& what, const std::string& why) const {
  if (source_->failure) return *source_->failure;
  return setpoints_error("setpoints-broken", "the archive is damaged: " + (what.empty() ? "" : what + ": ") + why,
                         {source_->file.name().string(), 0, 0}, "write it again, or copy it again");
}

Result<std::shared_ptr<ZipReader>> ZipReader::open(InputFile file) {
  std::shared_ptr<ZipReader> reader(new ZipReader);
  reader->source_ = std::make_unique<Source>(std::move(file));
  zip_error_t trouble;
  zip_error_init(&trouble);
  zip_source_t* const source = zip_source_function_create(&Source::answer, reader->source_.get(), &trouble);
  if (source != nullptr) reader->archive_ = zip_open_from_source(source, ZIP_RDONLY, &trouble);
  const std::string why = zip_error_strerror(&trouble);
  zip_error_fini(&trouble);
  if (reader->archive_ != nullptr) return reader;
  if (source != nullptr) zip_source_free(source);
  return tl::unexpected(reader->error("", why));
}

ZipReader::~ZipReader() {
  if (archive_ != nullptr) zip_discard(archive_);
}

Result<std::unique_ptr<ByteStream>> ZipReader::entry(const std::string& name) {
  const zip_int64_t index = zip_name_locate(archive_, name.c_str(), 0);
  if (index < 0) return nullptr;
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat_index(archive_, static_cast<zip_uint64_t>(index), 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0) {
    return tl::unexpected(error(name, zip_strerror(archive_)));
  }
  return std::make_unique<Entry>(shared_from_this(), static_cast<zip_uint64_t>(index), name, stat.size);
}

}  // namespace toolpace::detail
