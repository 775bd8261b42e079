#include "toolpace/verify/byte_stream.h"

#include <utility>

namespace toolpace::detail {
namespace {

class FileStream final : public ByteStream {
 public:
  explicit FileStream(InputFile file) : file_(std::move(file)) {}

  std::uint64_t size() const override { return file_.size(); }
  Result<void> read(char* out, std::size_t count) override {
    const std::uint64_t here = std::exchange(at_, at_ + count);
    return file_.read(here, out, count);
  }
  Result<void> finish() override { return file_.check_unchanged(); }
  void rewind() override { at_ = 0; }

 private:
  InputFile file_;
  std::uint64_t at_ = 0;
};

}  // namespace

std::unique_ptr<ByteStream> stream_of_file(InputFile file) { return std::make_unique<FileStream>(std::move(file)); }

}  // namespace toolpace::detail
