(run with: --set #13001=5)
O1 (section 7.4: SUP and SUV together are the start-up: here type B)
G10 L50
N5003 R00000001
G11
G90 G00 X20. Y-10.
G41 D1 G01 X0 Y0 F200 (expect moves: line X-5 Y-3.090)
Y50.
G40 X-20.
M30
