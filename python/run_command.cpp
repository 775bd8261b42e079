#include "run_command.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "console.h"
#include "report.h"

namespace toolpace::python {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{20};

/// Collects what a command says. Progress is read from another thread meanwhile.
class Listener final : public cli::Console {
 public:
  Listener(Ran& ran, std::shared_ptr<const Outcome> before, std::stop_token stop)
      : ran_(ran), before_(std::move(before)), stop_(std::move(stop)) {}

  void tell(std::string_view text) override { ran_.told += text; }
  void answer(const cli::Json& json) override { ran_.json = json.text(); }
  Monitor monitor(const char* what) override {
    fraction_ = 0.0;
    what_ = what;
    return {stop_, [this](double fraction) { fraction_ = fraction; }};
  }
  const Outcome* before() const override { return before_.get(); }
  void planned(Outcome outcome, const std::optional<Chain>& tip_of) override {
    ran_.plan = std::make_shared<const Outcome>(std::move(outcome));
    ran_.tip_of = tip_of;
  }
  void pulsed(const PulseTable& table) override { ran_.pulses = table; }

  Progress progress() const { return {what_, fraction_}; }

 private:
  Ran& ran_;
  std::shared_ptr<const Outcome> before_;
  std::stop_token stop_;
  std::atomic<const char*> what_ = nullptr;
  std::atomic<double> fraction_ = 0.0;
};

/// Runs `work` on a thread and `look` on this one until it is done.
void run_beside(const std::function<void()>& work, const std::function<bool()>& look, std::stop_source stop) {
  std::mutex mutex;
  std::condition_variable_any changed;
  bool is_done = false;
  std::exception_ptr thrown;
  std::jthread worker([&] {
    try {
      work();
    } catch (...) {
      thrown = std::current_exception();
    }
    const std::lock_guard lock(mutex);
    is_done = true;
    changed.notify_one();
  });
  for (std::unique_lock lock(mutex); !changed.wait_for(lock, kBetweenLooks, [&] { return is_done; });) {
    lock.unlock();
    if (!look()) stop.request_stop();
    lock.lock();
  }
  worker.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace

Ran run_command(const std::vector<std::string>& words, std::shared_ptr<const Outcome> before,
                const std::function<bool(const Progress&)>& look) {
  Ran ran;
  std::stop_source stop;
  Listener listener(ran, std::move(before), stop.get_token());
  const auto work = [&] {
    const cli::Done done = cli::run_words(words, listener);
    ran.has_failed = !done;
    ran.exit_code = done ? *done : cli::exit_code(done.error().error.kind);
    if (!done) ran.json = cli::to_json(done.error()).text();
  };
  run_beside(
      work, [&] { return look(listener.progress()); }, stop);
  return ran;
}

void work_beside(const std::function<void(const Monitor&)>& work, const std::function<bool()>& look) {
  std::stop_source stop;
  run_beside([&] { work({stop.get_token(), {}}); }, look, stop);
}

}  // namespace toolpace::python
