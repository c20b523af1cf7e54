#pragma once

#include <stdexcept>
#include <string>

namespace velum {

/// What kind of mistake an Error reports. The command line turns it into its exit code.
enum class ErrorKind {
  usage,      ///< an option or a parameter cannot be used as given
  read,       ///< a file cannot be opened, or its content cannot be understood
  write,      ///< a file cannot be written
  limit,      ///< more memory or more primitives than allowed would be needed
  cancelled,  ///< the progress callback asked to stop
};

/// A person's mistake (file, option, scene): what is wrong, where, and what to do about it.
///
/// what() reads "where: problem; remedy", with the empty parts left out.
class Error : public std::runtime_error {
 public:
  /// @param where  file, "file:line" or the option's name; may be empty
  /// @param remedy what the person can do; may be empty
  Error(ErrorKind kind, const std::string& problem, const std::string& where = {},
        const std::string& remedy = {});

  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace velum
