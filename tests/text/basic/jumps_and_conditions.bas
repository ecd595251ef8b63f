i=0
loop: i=i+1
if i<4 then goto loop
print i
if i=4 then print "four" else print "other"
if i<>4 then print "no"; else print "yes"
100 i=i+10
if i<40 then 100
print i
' (finally prints 4)
' (finally prints four)
' (finally prints yes)
' (finally prints 44)
