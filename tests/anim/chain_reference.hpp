// A chain of masses coupled by springs from 1 to 1e12 and more, moved exactly: what elastic bodies are judged by.
#pragma once

#include <vector>

#include "anim/elastic_body.hpp"
#include "tests/math/reference.hpp"

namespace morphcl::reference {

// N masses, springs of stiffness 100^i between masses i and i + 1 for N = 8, spread evenly up to the same 1e12 for
// other N; anchors of 1, damping 2 + 1e-8 K; 24 frames a second. Mass i is driven to ((7 k^2 + 3 k) mod 11) / 8 (1 +
// i/8) at frame k, along straight lines, from rest at 0.
SpringNet stiff_chain(std::size_t masses);
MorphDrive chain_drive(std::size_t masses, int frames);
constexpr TimeBase chain_time{24, 1};

// The positions at frames 0 to `frames`: the equation's matrix exponential in 120 digits, one step a frame.
std::vector<std::vector<Exact>> chain_motion(const SpringNet& net, int frames);

}  // namespace morphcl::reference
