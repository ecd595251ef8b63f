n=0
for i=1 to 3
 for j=i to 3
  n=n+1
 next j
next i
print n; i; j ' (expect n=6, i=4, j=4)
for x=0 to 1 step 0.1
m=m+1 ' (expect warning LW0001 at m)
next
print m; x ' (expect m=11, x=1.1)
for q=5 to 1
print "never"
next
print q
for q=5 to 1 step -2
print q;
next q
print "|"; q
' (finally prints 6 4 4)
' (finally prints 11 1.1)
' (finally prints 5)
' (finally prints 5 3 1 | -1)
