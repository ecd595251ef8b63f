(run with: --machine arm4)
O0001 (what counts is where the tip is, not what the words say)
G01 X200. Y0 F600.
G52 X100. Y50.
Y100. (expect moves: line X200 Y150)
X200. (expect alarm OUT_OF_REACH says the tip X300 Y150)
M30
(finally machine X200 Y150)
(finally work X100 Y100)
