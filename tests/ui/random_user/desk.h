#pragma once
/// The files on a random user's desk: good and bad programs and machines, and names to save under.

#include <QStringList>
#include <QTemporaryDir>
#include <random>

namespace toolpace::ui {

using Chance = std::mt19937_64;

/// A number from 0 to below `end`. The standard's distributions differ between libraries; this one does not.
inline int pick(Chance& chance, qsizetype end) {
  return end > 0 ? static_cast<int>(chance() % static_cast<std::uint64_t>(end)) : 0;
}
inline bool happens(Chance& chance, int percent) { return pick(chance, 100) < percent; }
template <class List>
const auto& one_of(Chance& chance, const List& list) {
  return list[static_cast<typename List::size_type>(pick(chance, static_cast<qsizetype>(list.size())))];
}

/// A folder of its own for work, and one for temporaries, which must be empty whenever nothing goes on.
class Desk {
 public:
  Desk();

  const QStringList& programs() const { return programs_; }  ///< also what is none, or not there
  const QStringList& machines() const { return machines_; }
  const QStringList& targets() const { return targets_; }  ///< what can be written, and what cannot
  QString folder() const { return work_.path(); }

  /// A program changes under the window: rewritten, cut off, removed or put back.
  void disturb(Chance& chance);
  /// Files that a save or a proof should have taken away, or anything that is left in the folder of temporaries.
  QStringList leftovers() const;

 private:
  void write(const QString& name, const QByteArray& text) const;

  QTemporaryDir work_, temporaries_;
  QStringList programs_, machines_, targets_;
};

/// Texts of a line of a program that people might type; some are wrong.
const QStringList& typed_lines();

}  // namespace toolpace::ui
