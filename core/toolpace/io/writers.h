#pragma once
/// The writers behind open_setpoint_writer(), one a family of formats. For use inside io/ alone.

#include <memory>

#include "toolpace/io/output_file.h"
#include "toolpace/io/setpoint_writer.h"

namespace toolpace::io_detail {

std::unique_ptr<SetpointWriter> make_text_writer(OutputFile file, SetpointFormat format,
                                                 const SetpointFileOptions& options);
std::unique_ptr<SetpointWriter> make_npy_writer(OutputFile file, const SetpointFileOptions& options);
Result<std::unique_ptr<SetpointWriter>> make_npz_writer(OutputFile file, const SetpointFileOptions& options);

}  // namespace toolpace::io_detail
