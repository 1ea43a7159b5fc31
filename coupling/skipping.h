// Certified skipping of RVE calls: what was asked almost the same before is answered from a table of records
// (answer_records.h).
//
// A batch goes in rounds. All ranks look up all points; of those that no record reaches, some far enough from
// each other are called, become records, and may answer the others, until none is left. So decisions are the
// same on all ranks and threads, and what is to be exchanged between ranks are the calls alone.
//
//   skipping.begin(F, request);
//   while (!skipping.calls().empty())
//     { call them, gather the table of answers; skipping.learn(F_dot, table); }
//   for p with skipping.from_table(p): RveAnswer = skipping.answer(p, F_dot, request);
//   skipping.end();
//
// - The viscous stress of the affine flow is computed exactly, and what the fluid of the cells does against a
// change of volume; E, S, energy, pressure and tangent are those of one record.
// - One answer in 1/audit_share, be its record old or of this batch, is computed after all and tells the
// error (skipping_audit.h); a record that it refutes shrinks.
// - A batch of the committed time (a probe) asks again what was asked before: it teaches nothing. Records
// that came since the last commit
//   are not saved, radii change at commit(): a resumed run goes on with the bits.
// - The table serves points to which nothing has happened for good, and a record reaches no farther than
// nothing can happen. All others
//   are called in full.
// - Where calls cost little more than looking up, all are called. That is decided by counted work, not by the
// clock, or bits would
//   depend on it.
//
// In: F (no unit), F_dot (1/s). Out: as rve.h has it.
#pragma once

#include "coupling/answer_records.h"
#include "coupling/answer_table.h"
#include "coupling/skipping_audit.h"
#include "coupling/skipping_settings.h"
#include "macro/material_law.h"
#include "rve/rve.h"

namespace turgor {
/// Counts of committed batches that were no probes, all points and ranks.
struct SkippingStatistics {
  std::uint64_t asks = 0;
  std::uint64_t answered = 0;      ///< from the table
  std::uint64_t with_history = 0;  ///< asks of points to which something has happened: called in full
  std::uint64_t refuted = 0;       ///< audits that found more than the tolerance
  std::uint64_t work = 0;          ///< of the calls: (iterations + 1) unknowns
  std::uint64_t calls = 0;
};

template <int dim>
class Skipping {
 public:
  /// Throws std::invalid_argument for an RVE whose answers cannot be told from F alone.
  Skipping(const Rve<dim> &rve, const SkippingSettings &settings);

  void set_points(std::size_t n);

  void begin(const std::vector<dealii::Tensor<2, dim>> &F, const LawRequest &request);
  /// Points to be called now, ascending; and whether their tangents are needed for records.
  const std::vector<std::size_t> &calls() const { return now; }
  bool needs_tangent(std::size_t point) const { return asked[point].kind == Kind::record; }
  void learn(const std::vector<dealii::Tensor<2, dim>> &F_dot, const AnswerTable<dim> &table);
  bool from_table(std::size_t point) const { return asked[point].kind == Kind::table; }
  RveAnswer<dim> answer(std::size_t point, const Tensor2<dim> &F_dot, const LawRequest &request) const;
  void end();

  /// The last batch becomes history, and what all since the last commit have taught counts.
  void commit();

  std::size_t records() const { return table.size(); }
  const SkippingStatistics &statistics() const { return total; }
  const SkippingAudit &audit() const { return audited; }
  bool worthwhile() const { return worth; }

  void archive(Archive &a);

 private:
  enum class Kind {
    table,    // is answered from it
    waiting,  // for a record of this batch
    record,   // called, to become one
    audit,    // called, though the table has an answer
    plain     // called: something has happened, or all are
  };
  struct Ask {
    Tensor2<dim> F;
    StrainVector<dim> E;
    std::size_t symmetry = 0, record = AnswerRecords<dim>::none;
    Kind kind = Kind::plain;
  };
  struct Finding  // of an audit
  {
    std::size_t record;
    double error, distance;  // Pa; of strains
  };

  Tensor2<dim> elastic_P(const Ask &ask) const;
  void serve(std::size_t point);
  void choose(const std::vector<std::size_t> &missing);
  void decide();

  SkippingSettings settings;
  double viscosity;
  bool keeps_history;
  double unknowns;  // of an RVE
  StrainFolding<dim> folding;
  AnswerRecords<dim> table;
  SkippingAudit audited;
  SkippingStatistics total, since;  // until the last commit; and since
  bool worth = true;

  std::vector<std::size_t> hint;  // per point: the record it used last
  std::vector<unsigned char> virgin,
      next;  // per point: nothing has happened, committed and by the last batch
  std::uint64_t batches = 0, batches_since = 0;
  std::size_t committed = 0;  // records

  // Of the batch under way.
  std::vector<Ask> asked;
  std::vector<std::size_t> now, waiting;
  std::vector<Finding> findings;  // since the last commit
  std::size_t at_begin = 0;
  int rounds = 0;
  bool teaches = false;
};
}  // namespace turgor
