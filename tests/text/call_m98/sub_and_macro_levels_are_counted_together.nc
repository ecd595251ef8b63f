(run with: --param total_levels=2)
O1 (NEST-1: the third call of any kind is one too many)
M98 P2
M30
O2
G65 P3
M99
O3
#100=1
M98 P4 (expect alarm PS0077)
M99
O4
M99
(finally #100=1)
