(run with: --param 6072=51)
O1 (section 6.4: 6072 is O9002)
M51 L3
M30
O9002
#100=#100+1
M99
(finally #100=3)
