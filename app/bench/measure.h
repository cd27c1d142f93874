// Times of repeated work, and what is said of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace glint {

struct Measurement {
  std::string name;
  double median = 0, minimum = 0, maximum = 0;   // milliseconds
  int count = 0;
  std::string note;                              // what else was found: an error, a size
};

// From the times of single runs, in milliseconds; at least one.
Measurement summarize(std::string name, std::vector<double> times, std::string note = {});

struct Effort {
  int warmUps = 3;              // runs that do not count
  int least = 9, most = 61;     // runs that do
  double seconds = 1.5;         // stop between least and most after this long
};
// Runs the work, which ends with a real wait for the device, and times each run.
Measurement measure(std::string name, const Effort&, const std::function<void()>& work, std::string note = {});

// Milliseconds of one run.
double timed(const std::function<void()>&);

}  // namespace glint
