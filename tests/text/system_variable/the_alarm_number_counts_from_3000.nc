O1 (section 3.1: 3000=1 is alarm 3001)
#3000=1(TOOL NOT FOUND) (expect alarm MC3001 says TOOL NOT FOUND)
#100=1
M30
(finally #100=null)
