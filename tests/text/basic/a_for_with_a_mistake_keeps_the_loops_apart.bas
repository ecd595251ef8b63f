for i=1 to 2
goto on
for j=1 2; print "bad"
next j
on: print i
next i
for k=3 to 1; x=5
next k
print k
' (finally prints 1)
' (finally prints 2)
' (finally prints 3)
