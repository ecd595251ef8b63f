O1 (VAR-9: X#1 with #1 vacant does not move)
G66 P2
X#1
Y1.
G67
M30
O2
#100=#100+1
M99
(finally #100=1)
