(run with: --param TCS=1)
O1 (section 6.4: the value of T is in #149)
T12
M30
O9000
#100=#149 (expect #100=12)
M99
