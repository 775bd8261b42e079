#pragma once
/// The writers of setpoint files, for the table of formats (setpoint_format.h).

#include <memory>

#include "toolpace/io/output_file.h"
#include "toolpace/io/setpoint_writer.h"

namespace toolpace::detail {

using MadeWriter = Result<std::unique_ptr<SetpointWriter>>;

MadeWriter make_csv_writer(OutputFile file, const SetpointFileOptions& options);
MadeWriter make_semicolon_writer(OutputFile file, const SetpointFileOptions& options);
MadeWriter make_halstream_writer(OutputFile file, const SetpointFileOptions& options);
MadeWriter make_npy_writer(OutputFile file, const SetpointFileOptions& options);
MadeWriter make_npz_writer(OutputFile file, const SetpointFileOptions& options);

}  // namespace toolpace::detail
