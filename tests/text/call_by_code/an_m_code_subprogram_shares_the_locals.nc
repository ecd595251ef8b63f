(run with: --param 6071=50)
O1 (section 6.4: called like M98, without arguments)
#1=5
M50
#100=#1 (expect #100=6)
M30
O9001
#1=#1+1
M99
