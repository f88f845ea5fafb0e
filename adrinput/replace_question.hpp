#pragma once

#include <filesystem>
#include <functional>

class QWidget;

namespace adore::adrinput {

/// "Another program changed the file since it was opened here": `replace` when the user wants to
/// save all the same. The box is a child named "changed".
void ask_to_replace(QWidget* parent, const std::filesystem::path& file,
                    std::function<void()> replace);

}  // namespace adore::adrinput
