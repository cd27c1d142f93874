// Messages to the person at the terminal, always on stderr: stdout belongs to a command's answer.
#pragma once

#include <string>

#include "materials/base/diagnostic.h"

namespace glint::log {

void setQuiet(bool);                // --quiet: errors only
void info(const std::string&);      // "glint: TEXT"
void report(const Diagnostic&);     // "glint: error: PLACE: WHAT; HINT"
void report(const Diagnostics&);
void setCollector(Diagnostics*);    // what is reported is also appended there, until set to null
// A line that replaces the one before it when stderr is a terminal; nothing otherwise. `fraction` 0..1;
// 1 ends the line.
void progress(const std::string& what, double fraction);

}  // namespace glint::log
