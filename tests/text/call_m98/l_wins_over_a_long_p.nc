O1 (CALL-1: both give a count, L is taken)
M98 P31002 L2
M30
O1002
#100=#100+1
M99
(finally #100=2)
