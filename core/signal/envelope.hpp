#pragma once

#include <vector>

/// Envelopes of modulated vibration.
namespace adore::signal {

/// Magnitude of the analytic signal of the part between two frequencies [Hz], both included: the
/// discrete transform of the samples without mean, twice its lines inside the band, none outside,
/// transformed back (band-pass and Hilbert transform in one step; Marple 1999). The transform is
/// periodic: a few times 1/(high - low) at both ends are affected by the other end.
/// A tone of amplitude A inside the band has the envelope A; A (1 + m cos b t) cos a t with all
/// three lines inside the band has A (1 + m cos b t), whose spectrum has a line A m at b.
/// Empty for fewer than four samples or a band without lines.
[[nodiscard]] std::vector<double> envelope(const std::vector<double>& samples, double step,
                                           double low, double high);

}  // namespace adore::signal
