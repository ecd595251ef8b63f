(run with: --machine mill3 --param overrun.X=0.5 --set #13001=2)
O1 (G-8: as for G53)
G41 D1 G01 X10. Y0 F100
Y20.
G60 X30. (expect moves: rapid X29.5 Y20; rapid X30 Y20)
G40 X0
M30
