(run with: --machine mill3 --param overrun.X=0.5 --param 5440.Y=-0.2)
O1 (G-8: X comes from below, Y from above, whatever the way was)
G60 X10. Y10. (expect moves: rapid X9.5 Y10.2 Z0 stop; rapid X10 Y10 Z0 stop)
G60 X5. Y20. (expect moves: rapid X4.5 Y20.2 stop; rapid X5 Y20 stop)
G91 G60 X1. Y-1. (expect moves: rapid X5.5 Y19.2 stop; rapid X6 Y19 stop)
M30
(finally assumed: none)
(finally work X6 Y19)
