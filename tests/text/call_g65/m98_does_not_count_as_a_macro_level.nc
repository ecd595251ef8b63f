(run with: --param macro_levels=1)
O1 (CALL-9: two subprograms below one macro)
G65 P2
M30
O2
M98 P3
M99
O3
M98 P4
M99
O4
#100=4
M99
(finally #100=4)
