O1 (VAR-1: #[#1] is the variable whose number #1 holds)
#1=5
#5=7
#100=#[#1] (expect #100=7)
M30
