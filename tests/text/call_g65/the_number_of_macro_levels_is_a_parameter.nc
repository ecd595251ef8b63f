(run with: --param macro_levels=5)
O1 (CALL-9: five levels as on a 30i)
G65 P2
M30
O2
G65 P3
M99
O3
G65 P4
M99
O4
G65 P5
M99
O5
G65 P6
M99
O6
#100=6
M99
(finally #100=6)
