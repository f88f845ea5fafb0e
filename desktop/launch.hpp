#pragma once

#include <QString>
#include <QStringList>

#include <functional>

/// Starting another program of the suite.
namespace adore::desktop {

/// Starts `program` (adrplot, agore, adrinput) as a separate process that outlives this one and
/// holds none of its streams. It is searched in the folder of this program, then in the PATH.
/// @throws InputError if it is not installed or does not start.
void start_program(const QString& program, const QStringList& arguments);

/// Starts the program at a path; false when that failed.
using Starter = std::function<bool(const QString& path, const QStringList& arguments)>;

/// Runs `program` (searched as by start_program) to its end. @return its standard output
/// @throws InputError with its last words when it fails, or when it is not installed
[[nodiscard]] QString output_of_program(const QString& program, const QStringList& arguments);

/// Replaces the function that start_program() uses (none: the default), for tests, which must not
/// leave windows. Returns the previous one.
Starter set_program_starter(Starter start);

}  // namespace adore::desktop
