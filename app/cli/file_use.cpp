#include "file_use.h"

#include "failure.h"
#include "toolpace/base/descriptor.h"
#include "toolpace/io/output_guard.h"

namespace toolpace::cli {

Result<void> FileUse::check(const std::vector<std::string>& sub_programs) const {
  std::vector<FileRole> inputs, outputs;
  for (const Named& input : inputs_) inputs.push_back({input.what, *input.file});
  for (const std::string& file : sub_programs) inputs.push_back({"the sub-program " + file, file});
  bool is_taken = json_ != nullptr && *json_;
  bool is_named = false;
  for (const Named& output : outputs_) {
    const bool is_standard = is_standard_output(*output.file);
    if (is_standard && is_taken) {
      return tl::unexpected(usage_error("two-outputs", "--json and " + output.what + " - both want standard output",
                                        "give " + output.what + " the name of a file"));
    }
    is_named |= is_standard;
    outputs.push_back({output.what, is_standard ? "-" : *output.file});
  }
  if (!is_named) outputs.push_back({"standard output", "-"});
  return check_outputs(outputs, inputs);
}

}  // namespace toolpace::cli
