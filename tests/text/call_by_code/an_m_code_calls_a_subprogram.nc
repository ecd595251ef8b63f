(run with: --param 6071=50)
O1 (section 6.4: M50 calls O9001)
M50
M50
M30
O9001
#100=#100+1
M99
(finally #100=2)
