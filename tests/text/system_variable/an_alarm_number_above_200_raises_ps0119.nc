O1 (section 3.1: n is 0 to 200)
#3000=201(TOO HIGH) (expect alarm PS0119)
M30
