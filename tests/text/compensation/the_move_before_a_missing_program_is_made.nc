(run with: --set #13001=5)
O1 (a failing call stops the program, not the moves commanded before it)
G90 G00 X-20. Y-10.
G41 D1 G01 X0 Y0 F200
Y50.
G65P9999 (expect alarm PS0076)
M30
(finally moves: rapid X-20 Y-10; line X-5 Y0 F200; line X-5 Y50)
