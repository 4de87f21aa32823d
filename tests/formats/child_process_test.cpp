#include "formats/binary/memory_file.h"
#include "formats/process/child_process.h"
#include "libmorph/core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <new>
#include <vector>

namespace {

using namespace morph;
using testing::HasSubstr;
using testing::IsEmpty;

const ChildLimits kLimits{std::size_t{64} << 20, 1};

/// What run_in_child() says of this work.
std::string end_of(const std::function<void()>& work)
{
    try {
        run_in_child("file", kLimits, work);
    } catch (const InputError& error) {
        return error.what();
    } catch (const SolverError& error) {
        return std::string("solver: ") + error.what();
    }
    return "done";
}

TEST(ChildProcess, LeavesItsWorkInMemoryAndChangesNothingHere)
{
    MemoryFile file;
    int number = 1;
    EXPECT_EQ(end_of([&] {
                  number = 2;
                  file.append("two");
              }),
              "done");
    EXPECT_EQ(number, 1);
    EXPECT_EQ(file.bytes(), "two");
}

TEST(ChildProcess, HandsItsErrorsOn)
{
    EXPECT_EQ(end_of([] { throw InputError("file:3: odd"); }), "file:3: odd");
    EXPECT_EQ(end_of([] { throw SolverError("no way"); }), "solver: no way");
    EXPECT_EQ(end_of([] { throw std::bad_alloc(); }),
              "file: took more memory than its size accounts for; it is damaged");
}

TEST(ChildProcess, TurnsACrashIntoAnError)
{
    EXPECT_THAT(end_of([] { std::raise(SIGSEGV); }), HasSubstr("file: damaged so that the library"));
    EXPECT_THAT(end_of([] { std::abort(); }), HasSubstr("file: damaged so that the library"));
    EXPECT_THAT(end_of([] { std::exit(7); }), HasSubstr("ended with status 7"));
}

TEST(ChildProcess, EndsWhatTakesTooLong)
{
    EXPECT_THAT(end_of([] {
                    for (std::atomic<int> i = 0;; ++i) {
                    }
                }),
                HasSubstr("took more time than its size accounts for"));
}

TEST(ChildProcess, EndsWhatWritesTooMuch)
{
    MemoryFile file;
    EXPECT_THAT(end_of([&] {
                    for (const std::string piece(1 << 20, 'x');;)
                        file.append(piece);
                }),
                HasSubstr("took more memory than its size accounts for"));
}

TEST(ChildProcess, IsSilent)
{
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_EQ(end_of([] {
                  std::cout << "noise" << std::endl;
                  std::cerr << "noise" << std::endl;
              }),
              "done");
    EXPECT_THAT(testing::internal::GetCapturedStdout(), IsEmpty());
    EXPECT_THAT(testing::internal::GetCapturedStderr(), IsEmpty());
}

} // namespace
