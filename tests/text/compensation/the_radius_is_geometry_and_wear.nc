(run with: --set #13001=5 --set #12001=0.1)
O1 (section 9: 5.1)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F100 (expect moves: line X-5.1 Y0)
Y50. (expect moves: line X-5.1 Y55.1)
X50.
G40 Y80.
M30
