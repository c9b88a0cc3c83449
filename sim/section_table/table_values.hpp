// What the section table holds at a node: the direct solution in the smooth quantities of
// core/hull/section_coordinates.hpp. And the nodes of the table.
#pragma once

#include <span>

#include "core/hull/section_coordinates.hpp"
#include "sim/section_table/multipole_solver.hpp"

namespace quickstrip {

/// Nodes, chosen by measurement (`--axes`).
std::span<const double> table_h0_nodes();
std::span<const double> table_fullness_nodes();
std::span<const double> table_kappa_nodes();

struct TableEntry {
  SectionQuantities quantities{};
  int num_multipoles = 0;  // 0 at kappa = 0: closed form
  bool converged = true;
};

TableEntry table_entry(double h0, double fullness, double kappa);

/// Smooth quantities of a direct solution at kappa > 0, and their closed forms at kappa = 0.
SectionQuantities smooth_quantities(double a1, double a3, double kappa, const SectionSolution& solution);
SectionQuantities smooth_quantities_at_zero(double a1, double a3);

}  // namespace quickstrip
