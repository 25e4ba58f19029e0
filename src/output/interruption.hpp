#pragma once

namespace impact {

/// From now on SIGINT and SIGTERM do not end the program, but are told by interrupted().
void take_interruptions();

/// True for good once one of the signals has come. May be called from any thread.
bool interrupted();

}  // namespace impact
