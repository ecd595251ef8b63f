(run with: --machine laser3)
O1 (PS0014: a laser has no spindle to measure)
G95 G01 X1. F0.1 (expect alarm PS0014 at G95)
M30
