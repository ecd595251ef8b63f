#pragma once

#include "machine/panel/operation.hpp"

namespace kerf::test {

// The keys of a panel by their names: machine.perform(CycleStart{}).
using machine::CycleStart;
using machine::EnterBlocks;
using machine::EnterLine;
using machine::FeedHold;
using machine::Home;
using machine::Interrupt;
using machine::Jog;
using machine::JogBy;
using machine::JogStop;
using machine::Load;
using machine::Raise;
using machine::Reset;
using machine::RunTo;
using machine::SetBlockSkip;
using machine::SetBreakpoints;
using machine::SetDials;
using machine::SetInput;
using machine::SetMemory;
using machine::SetMode;
using machine::SetOffset;
using machine::SetVariable;
using machine::StartAt;
using machine::StepBack;
using machine::TakeStep;
using machine::TurnSwitch;

}  // namespace kerf::test
