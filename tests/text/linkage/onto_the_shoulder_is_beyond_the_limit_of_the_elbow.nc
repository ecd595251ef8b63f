(run with: --machine arm4)
O0001 (the end of the move counts as well)
G01 X100. F600. (expect moves: line X100 Y0)
X0 (expect alarm LIMIT says T1)
M30
(finally machine X100)
