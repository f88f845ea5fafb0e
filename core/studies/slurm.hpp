#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

/// Output of the Slurm commands.
namespace adore::studies {

/// Output of a command, or nothing when it is not there or fails; `error` gets what it said.
[[nodiscard]] std::optional<std::string> command_output(const std::vector<std::string>& words,
                                                        std::string* error = nullptr);

/// Is it a number, as Slurm names jobs? Anything else could be an option of its commands.
[[nodiscard]] bool is_slurm_job(const std::string& text);

/// Processors of all nodes that are up. @throws InputError when there is no Slurm here, or none
/// that answers.
[[nodiscard]] int slurm_cores();
/// Largest number of array elements of one job, MaxArraySize of the configuration; 1001 unless it
/// says.
[[nodiscard]] long slurm_max_array_size();

/// Elements of a job that are not over, by state ("PENDING", "RUNNING" ...). Nothing: Slurm does
/// not answer.
[[nodiscard]] std::optional<std::map<std::string, int>> slurm_queue(const std::string& job);

/// How an element of a job ended.
struct SlurmExitState {
  std::string state;  ///< "COMPLETED", "TIMEOUT", "NODE_FAIL" ...; empty: nobody knows
  int exit_code = 0, signal = 0;
};
/// By element: from the accounting (sacct), or from the controller while it still knows the job
/// (scontrol), where no accounting runs.
[[nodiscard]] std::map<long, SlurmExitState> slurm_exit_states(const std::string& job);

}  // namespace adore::studies
