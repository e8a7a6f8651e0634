//! The `crossfibre` command.

fn main() -> std::process::ExitCode {
    crossfibre_verification::command::main()
}
