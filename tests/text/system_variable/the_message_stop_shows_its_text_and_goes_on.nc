O1 (section 3.1: #3006 in a run without an operator)
#3006=1(TURN THE PART)
#100=1 (expect #100=1)
M30
(finally records: message TURN THE PART)
