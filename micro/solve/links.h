// Links of two bodies, and who gives them to the matrix of motion (motion_matrix.h):
//
//   force on i = -[ tangential u + (normal - tangential) e (e.u) ],   u = v_i - v_j    (N s/m; e: unit vector
//     along the line, either way)
//
// A list that holds its pairs anyway is not copied: it derives from ListedLinks and goes through the links of
// one body. One pass serves the exact residual in double (ExactRow) and the copy in single precision
// (LinkRow, link_matrix.h):
//
//   struct Springs : ListedLinks<Springs> {
//     template <class Row> void links_of(std::size_t i, Row &row) const { row.link(normal, tangential, e,
//       other, true); }  // for all of i
//     void room(begin, end, count) const override;  bool directed() const override;
//   };
#pragma once

#include "micro/solve/eight_floats.h"

#include <cstdint>
#include <vector>

namespace turgor {
/// A vector of a body in double, the fourth number is 0.
using DoubleRow = double __attribute__((vector_size(32)));
struct BodyVector {
  DoubleRow v{};
};

/// Forces on bodies (N), by components (the third may be missing) or as rows.
struct Forces {
  const double *component[3] = {};
  const BodyVector *rows = nullptr;

  DoubleRow operator()(const std::size_t i) const {
    return rows != nullptr ? rows[i].v
                           : DoubleRow{component[0][i], component[1][i],
                                       component[2] != nullptr ? component[2][i] : 0., 0.};
  }
};

/// r_i = F_i - medium_i v_i - links, while the links of body i are gone through.
class ExactRow {
 public:
  ExactRow(const Forces &forces, const std::vector<double> &medium, const std::vector<BodyVector> &v_,
           const std::size_t i)
      : me(v_[i].v), rest(forces(i) - medium[i] * me), v(v_.data()) {}
  // one by one, so that a copy is kept in registers
  ExactRow(const ExactRow &other) : me(other.me), rest(other.rest), v(other.v) {}
  ExactRow &operator=(const ExactRow &other) = delete;
  void take(const ExactRow &done) { rest = done.rest; }
  /// normal, tangential: N s/m, zero where nothing touches; e[3] may be anything.
  void link(const double normal, const double tangential, const DoubleRow e, const std::uint32_t other,
            bool /*touches*/) {
    const DoubleRow u = me - v[other].v, along = e * u;  // u[3] = 0
    rest -= tangential * u + (normal - tangential) * ((along[0] + along[1]) + (along[2] + along[3])) * e;
  }
  DoubleRow result() const { return DoubleRow{rest[0], rest[1], rest[2], 0.}; }

 private:
  DoubleRow me, rest;
  const BodyVector *v;
};

/// The k-th links of eight bodies.
struct EightLinks {
  EightFloats tangential;  ///< N s/m, with the sign of normal - tangential (link_matrix.h)
  std::uint32_t other[8];
};

/// A row as it is assembled: the exact one, and each link in its lane of eight bodies.
template <bool with_lines>
class LinkRow : public ExactRow {
 public:
  LinkRow(const ExactRow &row, const double medium, EightLinks *links, FloatRow *lines,
          const std::size_t lane_)
      : ExactRow(row), all(medium), to(links), line(lines + (with_lines ? lane_ : 0)), lane(lane_) {}
  LinkRow(const LinkRow &other)
      : ExactRow(other), all(other.all), to(other.to), line(other.line), lane(other.lane) {}
  void take(const LinkRow &done) {
    ExactRow::take(done);
    all = done.all;
    to = done.to;
    line = done.line;
  }
  void link(const double normal, const double tangential, DoubleRow e, const std::uint32_t other,
            const bool touches) {
    ExactRow::link(normal, tangential, e, other, touches);
    all += tangential;
    to->tangential[lane] = float(tangential);
    to->other[lane] = other;
    if constexpr (with_lines) {
      e[3] = normal - tangential;
      *line = eight_floats::floats(e);
    }
    to += touches;  // the next one takes the place of one that does not touch
    if constexpr (with_lines) line += touches * 8;
  }
  double isotropic() const { return all; }  ///< N s/m, what does not depend on directions
  const EightLinks *end() const { return to; }

 private:
  double all;
  EightLinks *to;
  FloatRow *line;
  std::size_t lane;
};

/// Whom a body is linked to.
struct LinkedBodies {
  std::vector<std::uint32_t> others;
  void take(const LinkedBodies &done) { others = done.others; }
  void link(double, double, DoubleRow, const std::uint32_t other, const bool touches) {
    if (touches) others.push_back(other);
  }
};

/// Power that goes into the links of one body (W), half of it where the other body counts it too.
class PowerRow {
 public:
  PowerRow(const std::vector<BodyVector> &v_, const std::size_t i, const std::size_t bodies_)
      : me(v_[i].v), v(v_.data()), bodies(bodies_) {}
  PowerRow(const PowerRow &other) = default;
  void take(const PowerRow &done) { total = done.total; }
  void link(const double normal, const double tangential, const DoubleRow e, const std::uint32_t other,
            bool /*touches*/) {
    const DoubleRow u = me - v[other].v, along = e * u, square = u * u;  // u[3] = 0
    const double speed = (along[0] + along[1]) + along[2];
    total += (other < bodies ? 0.5 : 1.) *
             (tangential * ((square[0] + square[1]) + square[2]) + (normal - tangential) * speed * speed);
  }
  double result() const { return total; }

 private:
  DoubleRow me;
  const BodyVector *v;
  std::size_t bodies;
  double total = 0.;
};

/// What velocities cost by a matrix of motion A, W.
struct Power {
  double lost = 0.;    ///< v'Av of all bodies
  double given = 0.;   ///< of it what those of given velocity put in
  double pushed = 0.;  ///< what their motion does on the others: -v'A (velocities given, all else at rest)

  Power &operator+=(const Power &other) {
    lost += other.lost;
    given += other.given;
    pushed += other.pushed;
    return *this;
  }
};

class LinkSource {
 public:
  virtual ~LinkSource() = default;

  /// Not the same in all directions.
  virtual bool directed() const = 0;

  /// count[i - begin] += how many links body i has at most, for [begin, end).
  virtual void room(std::size_t begin, std::size_t end, std::uint32_t *count) const = 0;

  /// rows: of the bodies [i, i + count), so that a body's links are not worth a call of their own.
  virtual void add(std::size_t i, std::size_t count, ExactRow *rows) const = 0;
  virtual void add(std::size_t i, std::size_t count, LinkRow<true> *rows) const = 0;
  virtual void add(std::size_t i, std::size_t count, LinkRow<false> *rows) const = 0;
  virtual void add(std::size_t i, std::size_t count, LinkedBodies *rows) const = 0;
  virtual void add(std::size_t i, std::size_t count, PowerRow *rows) const = 0;
};

template <class List>
class ListedLinks : public LinkSource {
 public:
  void add(const std::size_t i, const std::size_t count, ExactRow *rows) const override {
    all_of(i, count, rows);
  }
  void add(const std::size_t i, const std::size_t count, LinkRow<true> *rows) const override {
    all_of(i, count, rows);
  }
  void add(const std::size_t i, const std::size_t count, LinkRow<false> *rows) const override {
    all_of(i, count, rows);
  }
  void add(const std::size_t i, const std::size_t count, LinkedBodies *rows) const override {
    all_of(i, count, rows);
  }
  void add(const std::size_t i, const std::size_t count, PowerRow *rows) const override {
    all_of(i, count, rows);
  }

 private:
  template <class Row>
  void all_of(const std::size_t i, const std::size_t count, Row *rows) const {
    for (std::size_t k = 0; k < count; ++k) {
      Row own(rows[k]);
      static_cast<const List &>(*this).links_of(i + k, own);
      rows[k].take(own);
    }
  }
};

/// Links that are pushed one by one.
class PushedLinks final : public ListedLinks<PushedLinks> {
 public:
  void clear();
  /// j may be a body of given velocity: from `bodies` of sort() on.
  void push(std::uint32_t i, std::uint32_t j, DoubleRow e, double normal, double tangential);
  /// By bodies [0, bodies); once, when all have been pushed.
  void sort(std::size_t bodies);
  bool empty() const { return links.empty(); }

  bool directed() const override { return any_directed; }
  void room(std::size_t begin, std::size_t end, std::uint32_t *count) const override;
  /// Of all links, whether they have been sorted or not; bodies of given velocity are those from `bodies` on.
  Power power(const BodyVector *v, std::size_t bodies) const;
  /// Both ends of all links, in the order in which they were pushed.
  void append_ends(std::vector<std::uint32_t> &to) const {
    for (const Pushed &link : links) {
      to.push_back(link.i);
      to.push_back(link.j);
    }
  }
  /// visit(i, j, e, normal, tangential), in the order in which they were pushed.
  template <class Visit>
  void for_all(const Visit &visit) const {
    for (const Pushed &link : links) visit(link.i, link.j, link.e, link.normal, link.tangential);
  }
  template <class Row>
  void links_of(const std::size_t i, Row &row) const {
    for (std::uint32_t k = first[i]; k < first[i + 1]; ++k) {
      const Pushed &link = links[of_body[k]];
      row.link(link.normal, link.tangential, link.e, link.i == i ? link.j : link.i, true);
    }
  }

 private:
  struct Pushed {
    DoubleRow e;
    double normal, tangential;
    std::uint32_t i, j;
  };
  std::vector<Pushed> links;
  std::vector<std::uint32_t> first, of_body;
  bool any_directed = false;
};
}  // namespace turgor
