O1 (section 12.5 as printed: END1 in the block of F)
#8=100.
G01 X1. F[8*#8] END1 (expect alarm PS0127)
M30
(finally moves: none)
