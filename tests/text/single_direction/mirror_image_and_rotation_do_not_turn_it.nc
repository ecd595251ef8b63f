(run with: --machine mill3 --param overrun.X=0.5 --param overrun.Y=0.25)
O1 (G-8: the direction is the machine's)
G51.1 X0
G60 X10. (expect moves: rapid X-10.5 stop; rapid X-10 stop)
G50.1 X0
G00 X0
G68 X0 Y0 R90.
G60 X10. (expect moves: rapid X0 Y9.75; rapid X0 Y10)
G69
M30
