/// toolpace._core: what the Python package needs of C++. The functions that people call are made in toolpace/__init__.py.

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>

#include "commands.h"
#include "run_command.h"
#include "setpoint_array.h"
#include "version.h"

namespace py = pybind11;

namespace toolpace::python {
namespace {

/// Whether nothing that Python wants to do now (Ctrl-C) ends what is being done. To be called without the GIL.
class Attention {
 public:
  explicit Attention(py::object progress) : progress_(std::move(progress)) {}

  bool look(const Progress& at) {
    const py::gil_scoped_acquire held;
    if (thrown_) return false;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress_.is_none() && at.what) progress_(at.what, at.fraction);
    } catch (py::error_already_set& e) {
      thrown_ = std::make_unique<py::error_already_set>(std::move(e));
    }
    return !thrown_;
  }
  /// To be called with the GIL, when the work is over.
  void throw_again() const {
    if (thrown_) throw py::error_already_set(*thrown_);
  }

 private:
  py::object progress_;
  std::unique_ptr<py::error_already_set> thrown_;
};

/// An array over memory that it keeps alive: nothing is copied.
template <class T>
py::array_t<T> array_over(std::vector<T> values, std::vector<py::ssize_t> shape) {
  auto owner = std::make_unique<std::vector<T>>(std::move(values));
  T* const data = owner->data();
  py::capsule capsule(owner.get(), [](void* kept) { delete static_cast<std::vector<T>*>(kept); });
  owner.release();
  return py::array_t<T>(std::move(shape), data, capsule);
}

std::string grammar() {
  cli::CommandLine line;
  cli::add_commands(line);
  return line.grammar().text();
}

Ran run(const std::vector<std::string>& words, std::shared_ptr<const Outcome> before, py::object progress) {
  Attention attention(std::move(progress));
  Ran ran;
  {
    const py::gil_scoped_release released;
    ran = run_command(words, std::move(before), [&](const Progress& at) { return attention.look(at); });
  }
  attention.throw_again();
  return ran;
}

/// (names, values, lines)
py::tuple setpoints(const Outcome& outcome, const std::optional<Chain>& tip_of) {
  Attention attention{py::none()};
  Result<SetpointArray> array;
  {
    const py::gil_scoped_release released;
    work_beside([&](const Monitor& monitor) { array = setpoint_array(outcome, tip_of, monitor); },
                [&] { return attention.look({}); });
  }
  attention.throw_again();
  if (!array) throw std::runtime_error(array.error().message);
  const auto rows = static_cast<py::ssize_t>(array->lines.size());
  const auto columns = static_cast<py::ssize_t>(array->names.size());
  return py::make_tuple(py::tuple(py::cast(array->names)), array_over(std::move(array->values), {rows, columns}),
                        array_over(std::move(array->lines), {rows}));
}

py::array_t<std::uint32_t> ticks(const PulseTable& table) {
  std::vector<std::uint32_t> ticks(table.move().steps);
  {
    const py::gil_scoped_release released;
    table.read(0, ticks);
  }
  const auto count = static_cast<py::ssize_t>(ticks.size());
  return array_over(std::move(ticks), {count});
}

}  // namespace
}  // namespace toolpace::python

PYBIND11_MODULE(_core, m) {
  using namespace toolpace;
  using namespace toolpace::python;
  py::class_<Chain>(m, "Chain");
  py::class_<Outcome, std::shared_ptr<Outcome>>(m, "Plan").def("setpoints", &setpoints);
  py::class_<PulseTable>(m, "Pulses").def("ticks", &ticks);
  py::class_<Ran>(m, "Ran")
      .def_readonly("exit_code", &Ran::exit_code)
      .def_readonly("has_failed", &Ran::has_failed)
      .def_property_readonly("json", [](const Ran& ran) { return py::bytes(ran.json); })
      .def_property_readonly("told", [](const Ran& ran) { return py::bytes(ran.told); })
      .def_property_readonly("plan", [](const Ran& ran) { return std::const_pointer_cast<Outcome>(ran.plan); })
      .def_readonly("tip_of", &Ran::tip_of)
      .def_readonly("pulses", &Ran::pulses);
  m.def("grammar", &grammar);
  m.def("version", &version);
  m.def("run", [](const std::vector<std::string>& words, std::shared_ptr<Outcome> before, py::object progress) {
    return toolpace::python::run(words, std::move(before), std::move(progress));
  });
}
