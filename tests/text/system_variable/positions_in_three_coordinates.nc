(run with: --set #11001=100)
O1 (section 3.3: work, machine and length offset)
#5223=-300.
G90 G43 H1 Z10.
#100=#5003 (expect #100=10)
#101=#5043 (expect #101=110)
#102=#5083 (expect #102=100)
#103=#5023 (expect #103=-190)
M30
