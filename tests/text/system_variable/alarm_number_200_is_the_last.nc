O1 (section 3.1: n is 0 to 200)
#3000=200(LAST) (expect alarm MC3200 says LAST)
M30
