O1 (NUM-16: 54.1 behind G is G54.1)
#7001=5.
#2=54.1
G#2 P1
G90 G00 X0 (expect moves: rapid X5)
#100=#4014 (expect #100=54.1)
M30
