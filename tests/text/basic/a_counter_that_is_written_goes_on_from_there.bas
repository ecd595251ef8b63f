n=0
for i=1 to 10
n=n+1
if i=3 then i=7.5
next
print n; i
' (finally prints 5 10.5)
