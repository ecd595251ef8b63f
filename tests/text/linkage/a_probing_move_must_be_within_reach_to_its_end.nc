(run with: --machine arm4 --skip-at X=220)
O0001 (nobody knows before whether the signal comes)
G01 X200. Y50. F600.
G31 X300. F100. (expect alarm OUT_OF_REACH) (expect moves: none)
M30
(finally machine X200 Y50)
