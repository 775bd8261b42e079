#pragma once
/// An orderly end when the system asks for one.

class QObject;

namespace toolpace::studio {

/// SIGINT, SIGTERM, SIGHUP and SIGQUIT end the event loops, so that what is being written is given up and leaves no
/// temporary file; nobody is asked. The same signal again ends at once. A closed pipe and a file that may not grow become
/// error values.
///
/// @param owner  an object of the thread that runs the event loops; has to live as long as they do
void end_on_signals(QObject* owner);

/// True once such a signal came.
bool is_ended();

}  // namespace toolpace::studio
