#include "support/planned.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>

#include "places.h"
#include "toolpace/machine/setup.h"

namespace toolpace::ui {

Program::Program(const AxisVector& start) {
  moves_.start = start;
  moves_.files = {"test.ngc"};
}

void Program::add(MoveKind kind, const AxisVector& end, double feed, std::uint32_t detail) {
  moves_.kind.push_back(kind);
  moves_.line.push_back(static_cast<std::uint32_t>(moves_.size()));
  moves_.file.push_back(0);
  moves_.mode.push_back(0);
  moves_.detail.push_back(detail);
  moves_.end.push_back(end);
  moves_.feed.push_back(feed);
}

Program& Program::rapid(double x, double y, double z) {
  AxisVector end = AxisVector::Zero();
  end.head<3>() << x, y, z;
  add(MoveKind::rapid, end, 0);
  return *this;
}

Program& Program::feed(double x, double y, double z, double feed) {
  AxisVector end = AxisVector::Zero();
  end.head<3>() << x, y, z;
  add(MoveKind::feed, end, feed);
  return *this;
}

Program& Program::arc(double x, double y, double z, double cx, double cy, double sweep, double feed) {
  AxisVector end = AxisVector::Zero();
  end.head<3>() << x, y, z;
  const double level = moves_.empty() ? moves_.start[2] : moves_.end.back()[2];
  moves_.arcs.push_back({{cx, cy, level}, Eigen::Vector3d::UnitZ(), sweep});
  add(MoveKind::arc, end, feed, static_cast<std::uint32_t>(moves_.arcs.size() - 1));
  return *this;
}

Program& Program::dwell(double seconds) {
  moves_.dwells.push_back(seconds);
  add(MoveKind::dwell, moves_.empty() ? moves_.start : moves_.end.back(), 0,
      static_cast<std::uint32_t>(moves_.dwells.size() - 1));
  return *this;
}

std::shared_ptr<const Reading> Program::reading() const {
  auto reading = std::make_shared<Reading>();
  reading->moves = moves_;
  return reading;
}

Program read_simple(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot open " + file);
  Program program;
  double x = 0, y = 0, z = 0, feed = 0;
  bool rapid = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '(' || line[0] == '%' || line[0] == ';') continue;
    const auto word = [&](char letter, double& value) {
      const auto at = line.find(letter);
      if (at == std::string::npos) return false;
      value = std::stod(line.substr(at + 1));
      return true;
    };
    if (line.find("G0") != std::string::npos) rapid = true;
    if (line.find("G1") != std::string::npos && line.find("G17") == std::string::npos) rapid = false;
    double per_minute = 0;
    if (word('F', per_minute)) feed = per_minute / 60;
    const bool has_x = word('X', x), has_y = word('Y', y), has_z = word('Z', z);
    if (!has_x && !has_y && !has_z) continue;
    rapid ? program.rapid(x, y, z) : program.feed(x, y, z, feed);
  }
  return program;
}

std::shared_ptr<const Outcome> planned(const Program& program, const PlanOptions& options, Machine machine) {
  auto job = std::make_shared<Job>();
  job->program_name = "test.ngc";
  job->program = program.reading();
  const bool bounded = machine.path.speed < kUnlimited;
  job->machine = bounded ? machine : default_setup().machine;
  if (!bounded) job->machine.axes = machine.axes;
  job->options = options;
  auto outcome = run(job);
  if (!outcome) throw std::runtime_error(outcome.error().message);
  return std::make_shared<const Outcome>(std::move(*outcome));
}

std::shared_ptr<const Outcome> planned_butterfly(const PlanOptions& options) {
  return planned(read_simple((test::source_dir() / "examples/nc/butterfly.ngc").string()), options);
}

Program winding(std::size_t blocks) {
  Program program;
  double angle = 0, x = 0, y = 0;
  for (std::size_t i = 0; i < blocks; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(blocks) * 400;
    angle = 2 * std::numbers::pi * u + 0.7 * std::sin(0.013 * static_cast<double>(i));
    const double radius = 2 + u * 0.4;
    x = radius * std::cos(angle);
    y = radius * std::sin(angle);
    program.feed(x, y, 2 * std::sin(u / 9), 50);
  }
  return program;
}

}  // namespace toolpace::ui
