(run with: --set #1000=1 --set #1003=1)
O1 (section 3.1: #1032 is the sum of the bits)
#100=#1032 (expect #100=9)
M30
